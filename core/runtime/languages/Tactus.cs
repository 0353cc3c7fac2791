// libtactus for .NET, Mono and Unity: the force of a Tactus model. One file; put it beside your code, and libtactus
// (libtactus.so.1, or tactus.dll on Windows) where the runtime looks for native libraries.
//
//   using (var model = Tactus.Model.Open("model.tactus.json"))
//   using (var scene = model.Scene(new Dictionary<string, double> {{"lubrication", 1.0}, {"neck_flexion", 45.0}}))
//   using (var tube = new Tactus.Tube(scene))
//       feel = tube.Step(positionMm, held, 0.001);
//
// What each call does, and which threads may call it: tactus/tactus.h. Force, ForceBatch and Step allocate nothing.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Tactus
{
    public enum Status { Ok = 0, BadArgument = 1, BadFile = 2, NoMemory = 3, NotVerified = 4 }

    /// One sentence: what, where, what was found, what was wanted.
    public sealed class Error : Exception
    {
        public readonly Status Status;
        public Error(Status status, string sentence) : base(sentence) { Status = status; }
    }

    /// What the hand feels after one step; the names and units of tactus_feel.
    [StructLayout(LayoutKind.Sequential)]
    public struct Feel
    {
        internal UIntPtr Size;
        public double ForceN, DepthMm, SpeedMmS, SlipSpeedMmS, StretchMm, ModelForceN;
        public int Phase, HeldLast;
        public uint Stroke;
        public int Limited;
        /// Index in TermIds of the depth; -1: none.
        public int Region;
    }

    /// The parameters of the tube; the names and units of tactus_renderer.
    [StructLayout(LayoutKind.Sequential)]
    public struct Renderer
    {
        internal UIntPtr Size;
        public double StiffnessNMm, DampingNSMm, BreakawayRatio, RestickMm, WithdrawalRatio, RelaxationS, AgeingS,
            StickSpeedMmS, StickTimeS, VelocityFilterHz, SlewNS, DepthOffsetMm;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Limits
    {
        internal UIntPtr Size;
        internal double StiffnessMaxNMm, ForceCapN;
    }

    internal static class Native
    {
#if UNITY_IOS && !UNITY_EDITOR
        private const string Library = "__Internal";
#elif UNITY_5_3_OR_NEWER || TACTUS_DLL // on Windows without Unity, define TACTUS_DLL
        private const string Library = "tactus";
#else
        private const string Library = "libtactus.so.1";
#endif
        private const CallingConvention C = CallingConvention.Cdecl;

        [DllImport(Library, CallingConvention = C)] internal static extern IntPtr tactus_version();
        [DllImport(Library, CallingConvention = C)] internal static extern int tactus_interface();
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_model_open(byte[] path, out IntPtr model, byte[] message, UIntPtr size);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_model_read(byte[] text, UIntPtr textSize, out IntPtr model, byte[] message,
                                                        UIntPtr size);
        [DllImport(Library, CallingConvention = C)] internal static extern void tactus_model_free(IntPtr model);
        [DllImport(Library, CallingConvention = C)] internal static extern IntPtr tactus_model_name(IntPtr model);
        [DllImport(Library, CallingConvention = C)] internal static extern UIntPtr tactus_model_inputs(IntPtr model);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_input_id(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)] internal static extern IntPtr tactus_model_sha256(IntPtr model);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_input_label(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_input_role(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)]
        internal static extern UIntPtr tactus_model_input_terms(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_term_id(IntPtr model, UIntPtr input, UIntPtr term);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_term_label(IntPtr model, UIntPtr input, UIntPtr term);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_model_membership(IntPtr model, UIntPtr expert, UIntPtr input, UIntPtr term,
                                                              double x);
        [DllImport(Library, CallingConvention = C)]
        internal static extern void tactus_model_renderer(IntPtr model, ref Renderer renderer);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_input_unit(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_model_input_min(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_model_input_max(IntPtr model, UIntPtr input);
        [DllImport(Library, CallingConvention = C)] internal static extern double tactus_model_output_min(IntPtr model);
        [DllImport(Library, CallingConvention = C)] internal static extern double tactus_model_output_max(IntPtr model);
        [DllImport(Library, CallingConvention = C)] internal static extern UIntPtr tactus_model_experts(IntPtr model);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_expert_id(IntPtr model, UIntPtr expert);
        [DllImport(Library, CallingConvention = C)]
        internal static extern IntPtr tactus_model_expert_label(IntPtr model, UIntPtr expert);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_model_expert_weight(IntPtr model, UIntPtr expert);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_force(IntPtr model, double[] inputs, out int fired);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_expert_force(IntPtr model, UIntPtr expert, double[] inputs, out int fired);
        [DllImport(Library, CallingConvention = C)]
        internal static extern void tactus_force_batch(IntPtr model, double[] inputs, UIntPtr points, double[] force,
                                                       byte[] fired);
        [DllImport(Library, CallingConvention = C)]
        internal static extern int tactus_clamped(IntPtr model, double[] inputs);
        [DllImport(Library, CallingConvention = C)]
        internal static extern uint tactus_clamped_inputs(IntPtr model, double[] inputs);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_scene_make(IntPtr model, UIntPtr[] inputs, double[] values, UIntPtr count,
                                                        out IntPtr scene, byte[] message, UIntPtr size);
        [DllImport(Library, CallingConvention = C)] internal static extern void tactus_scene_free(IntPtr scene);
        [DllImport(Library, CallingConvention = C)] internal static extern UIntPtr tactus_scene_inputs(IntPtr scene);
        [DllImport(Library, CallingConvention = C)]
        internal static extern double tactus_scene_force(IntPtr scene, double[] inputs, out int fired);
        [DllImport(Library, CallingConvention = C)]
        internal static extern void tactus_scene_force_batch(IntPtr scene, double[] inputs, UIntPtr points,
                                                             double[] force, byte[] fired);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_tube_make(IntPtr scene, out IntPtr tube, byte[] message, UIntPtr size);
        [DllImport(Library, CallingConvention = C)] internal static extern void tactus_tube_free(IntPtr tube);
        [DllImport(Library, CallingConvention = C)]
        internal static extern void tactus_tube_place(IntPtr tube, double depthMm);
        [DllImport(Library, CallingConvention = C)]
        internal static extern void tactus_tube_scene(IntPtr tube, IntPtr scene, double fadeS);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_tube_step(IntPtr tube, double positionMm, int held, double dtS,
                                                       ref Feel feel);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_tube_limits(IntPtr tube, ref Limits limits);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_tube_copy(IntPtr tube, out IntPtr copy);
        [DllImport(Library, CallingConvention = C)]
        internal static extern UIntPtr tactus_tube_save(IntPtr tube, byte[] bytes, UIntPtr size);
        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_tube_load(IntPtr tube, byte[] bytes, UIntPtr size);

        [DllImport(Library, CallingConvention = C)]
        internal static extern Status tactus_verify(byte[] folder, out double errorN, byte[] message, UIntPtr size);

        private const int Interface = 2;
        private const int MessageBytes = 1024;

        /// An older library lacks functions of this file.
        internal static void WantInterface()
        {
            int found = tactus_interface();
            if (found < Interface)
                throw new Error(Status.BadArgument, "libtactus: found interface " + found + ", wanted " + Interface +
                                                        " or later: this Tactus.cs is newer than the library");
        }

        internal delegate Status Make(out IntPtr handle, byte[] message, UIntPtr size);

        /// Runs a call that makes a handle, and throws its sentence where it fails.
        internal static IntPtr Made(Make make, out string warning)
        {
            var message = new byte[MessageBytes];
            IntPtr handle;
            Status status = make(out handle, message, (UIntPtr)MessageBytes);
            int length = Array.IndexOf(message, (byte)0);
            warning = Encoding.UTF8.GetString(message, 0, length);
            if (status != Status.Ok) throw new Error(status, warning);
            return handle;
        }

        internal static byte[] Bytes(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }

        internal static string Text(IntPtr text)
        {
            if (text == IntPtr.Zero) return null;
            int length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        internal static void Want(double[] inputs, int count)
        {
            if (inputs == null || inputs.Length != count)
                throw new Error(Status.BadArgument, "inputs: found " + (inputs == null ? 0 : inputs.Length) +
                                                        " values, wanted " + count);
        }
    }

    /// What has a handle of the library. After Dispose every call throws.
    public abstract class Owned : IDisposable
    {
        private IntPtr handle_;

        internal Owned(IntPtr handle) { handle_ = handle; }

        internal IntPtr Handle
        {
            get
            {
                if (handle_ == IntPtr.Zero) throw new ObjectDisposedException(GetType().FullName);
                return handle_;
            }
        }

        internal abstract void Free(IntPtr handle);

        public void Dispose()
        {
            Release();
            GC.SuppressFinalize(this);
        }

        private void Release()
        {
            IntPtr handle = System.Threading.Interlocked.Exchange(ref handle_, IntPtr.Zero);
            if (handle != IntPtr.Zero) Free(handle);
        }

        ~Owned() { Release(); }
    }

    public static class Bundle
    {
        /// Reads a bundle again; the largest error of the forces that it could evaluate, N. Throws where it is not as
        /// promised.
        public static double Verify(string folder)
        {
            double errorN = 0;
            string warning;
            Native.Made((out IntPtr none, byte[] message, UIntPtr size) =>
            {
                none = IntPtr.Zero;
                return Native.tactus_verify(Native.Bytes(folder), out errorN, message, size);
            }, out warning);
            return errorN;
        }
    }

    /// A model file in memory. Any number of threads.
    public sealed class Model : Owned
    {
        public readonly string Warning;
        public readonly string Name, Sha256;
        public readonly int Inputs;
        public readonly string[] InputIds, InputLabels, InputUnits, InputRoles, ExpertIds, ExpertLabels;
        /// The words of each input, such as the regions of the depth.
        public readonly string[][] TermIds, TermLabels;
        public readonly double[] InputMin, InputMax, ExpertWeights;
        public readonly double OutputMin, OutputMax;

        private Model(IntPtr handle, string warning) : base(handle)
        {
            Warning = warning;
            Name = Native.Text(Native.tactus_model_name(handle));
            Sha256 = Native.Text(Native.tactus_model_sha256(handle));
            Inputs = (int)Native.tactus_model_inputs(handle);
            InputIds = new string[Inputs];
            InputLabels = new string[Inputs];
            TermIds = new string[Inputs][];
            TermLabels = new string[Inputs][];
            InputUnits = new string[Inputs];
            InputRoles = new string[Inputs];
            InputMin = new double[Inputs];
            InputMax = new double[Inputs];
            for (int i = 0; i < Inputs; ++i)
            {
                InputIds[i] = Native.Text(Native.tactus_model_input_id(handle, (UIntPtr)i));
                InputLabels[i] = Native.Text(Native.tactus_model_input_label(handle, (UIntPtr)i));
                var terms = new string[(int)Native.tactus_model_input_terms(handle, (UIntPtr)i)];
                TermIds[i] = terms;
                TermLabels[i] = new string[terms.Length];
                for (int t = 0; t < terms.Length; ++t)
                {
                    terms[t] = Native.Text(Native.tactus_model_term_id(handle, (UIntPtr)i, (UIntPtr)t));
                    TermLabels[i][t] = Native.Text(Native.tactus_model_term_label(handle, (UIntPtr)i, (UIntPtr)t));
                }
                InputRoles[i] = Native.Text(Native.tactus_model_input_role(handle, (UIntPtr)i));
                InputUnits[i] = Native.Text(Native.tactus_model_input_unit(handle, (UIntPtr)i));
                InputMin[i] = Native.tactus_model_input_min(handle, (UIntPtr)i);
                InputMax[i] = Native.tactus_model_input_max(handle, (UIntPtr)i);
            }
            OutputMin = Native.tactus_model_output_min(handle);
            OutputMax = Native.tactus_model_output_max(handle);
            int experts = (int)Native.tactus_model_experts(handle);
            ExpertIds = new string[experts];
            ExpertLabels = new string[experts];
            ExpertWeights = new double[experts];
            for (int i = 0; i < experts; ++i)
            {
                ExpertIds[i] = Native.Text(Native.tactus_model_expert_id(handle, (UIntPtr)i));
                ExpertLabels[i] = Native.Text(Native.tactus_model_expert_label(handle, (UIntPtr)i));
                ExpertWeights[i] = Native.tactus_model_expert_weight(handle, (UIntPtr)i);
            }
        }

        public static Model Open(string path)
        {
            Native.WantInterface();
            string warning;
            IntPtr handle = Native.Made((out IntPtr model, byte[] message, UIntPtr size) =>
                Native.tactus_model_open(Native.Bytes(path), out model, message, size), out warning);
            return new Model(handle, warning);
        }

        public static Model Read(string text)
        {
            Native.WantInterface();
            byte[] bytes = Encoding.UTF8.GetBytes(text);
            string warning;
            IntPtr handle = Native.Made((out IntPtr model, byte[] message, UIntPtr size) =>
                Native.tactus_model_read(bytes, (UIntPtr)bytes.Length, out model, message, size), out warning);
            return new Model(handle, warning);
        }

        public double Force(double[] inputs) { bool fired; return Force(inputs, out fired); }

        public double Force(double[] inputs, out bool fired)
        {
            Native.Want(inputs, Inputs);
            int any;
            double forceN = Native.tactus_force(Handle, inputs, out any);
            GC.KeepAlive(this);  // or the finalizer could free the model during the call
            fired = any != 0;
            return forceN;
        }

        public double ExpertForce(int expert, double[] inputs)
        {
            Native.Want(inputs, Inputs);
            Place("expert", expert, ExpertIds.Length);
            int any;
            double forceN = Native.tactus_expert_force(Handle, (UIntPtr)expert, inputs, out any);
            GC.KeepAlive(this);
            return forceN;
        }

        /// Points one after another; `forceN` holds one value for each. `fired` may be null.
        public void ForceBatch(double[] inputs, double[] forceN, byte[] fired)
        {
            Native.Want(inputs, Inputs * forceN.Length);
            if (fired != null && fired.Length < forceN.Length)
                throw new Error(Status.BadArgument, "fired: found " + fired.Length + " values, wanted " + forceN.Length);
            Native.tactus_force_batch(Handle, inputs, (UIntPtr)forceN.Length, forceN, fired);
            GC.KeepAlive(this);
        }

        /// Whether an input is outside its universe and is clamped.
        public bool Clamped(double[] inputs) { return ClampedInputs(inputs) != 0; }

        /// Bit i: input i is.
        public uint ClampedInputs(double[] inputs)
        {
            Native.Want(inputs, Inputs);
            uint bits = Native.tactus_clamped_inputs(Handle, inputs);
            GC.KeepAlive(this);
            return bits;
        }

        /// The membership, 0 to 1, of the value x in a term of an input, as the expert's rules take it.
        public double Membership(int expert, int input, int term, double x)
        {
            Place("expert", expert, ExpertIds.Length);
            Place("input", input, Inputs);
            Place("term", term, TermIds[input].Length);
            double membership =
                Native.tactus_model_membership(Handle, (UIntPtr)expert, (UIntPtr)input, (UIntPtr)term, x);
            GC.KeepAlive(this);
            return membership;
        }

        private static void Place(string what, int found, int count)
        {
            if (found < 0 || found >= count)
                throw new Error(Status.BadArgument, what + ": found " + found + ", wanted 0 to " + (count - 1));
        }

        /// The parameters of the tube.
        public Renderer Renderer
        {
            get
            {
                var renderer = new Renderer { Size = (UIntPtr)(uint)Marshal.SizeOf(typeof(Renderer)) };
                Native.tactus_model_renderer(Handle, ref renderer);
                GC.KeepAlive(this);
                return renderer;
            }
        }

        /// The model with some inputs fixed, by id.
        public Scene Scene(IDictionary<string, double> fixedInputs)
        {
            var indices = new UIntPtr[fixedInputs.Count];
            var values = new double[fixedInputs.Count];
            int next = 0;
            foreach (var one in fixedInputs)
            {
                int index = Array.IndexOf(InputIds, one.Key);
                if (index < 0)
                    throw new Error(Status.BadArgument, "scene: found the input '" + one.Key + "', wanted one of " +
                                                            string.Join(", ", InputIds));
                indices[next] = (UIntPtr)index;
                values[next++] = one.Value;
            }
            string warning;
            IntPtr handle = Native.Made((out IntPtr scene, byte[] message, UIntPtr size) =>
                Native.tactus_scene_make(Handle, indices, values, (UIntPtr)indices.Length, out scene, message, size),
                out warning);
            GC.KeepAlive(this);
            return new Scene(handle, warning);
        }

        internal override void Free(IntPtr handle) { Native.tactus_model_free(handle); }
    }

    /// A model with some inputs fixed; made by Model.Scene. Any number of threads.
    public sealed class Scene : Owned
    {
        public readonly string Warning;
        public readonly int Inputs;

        internal Scene(IntPtr handle, string warning) : base(handle)
        {
            Warning = warning;
            Inputs = (int)Native.tactus_scene_inputs(handle);
        }

        public double Force(double[] inputs) { bool fired; return Force(inputs, out fired); }

        public double Force(double[] inputs, out bool fired)
        {
            Native.Want(inputs, Inputs);
            int any;
            double forceN = Native.tactus_scene_force(Handle, inputs, out any);
            GC.KeepAlive(this);
            fired = any != 0;
            return forceN;
        }

        public void ForceBatch(double[] inputs, double[] forceN, byte[] fired)
        {
            Native.Want(inputs, Inputs * forceN.Length);
            if (fired != null && fired.Length < forceN.Length)
                throw new Error(Status.BadArgument, "fired: found " + fired.Length + " values, wanted " + forceN.Length);
            Native.tactus_scene_force_batch(Handle, inputs, (UIntPtr)forceN.Length, forceN, fired);
            GC.KeepAlive(this);
        }

        internal override void Free(IntPtr handle) { Native.tactus_scene_free(handle); }
    }

    /// One insertion: position in, force out. One thread at a time.
    public sealed class Tube : Owned
    {
        private static readonly UIntPtr feel_size_ = (UIntPtr)(uint)Marshal.SizeOf(typeof(Feel));

        public Tube(Scene scene) : base(Made(scene)) {}
        private Tube(IntPtr handle) : base(handle) {}

        private static IntPtr Made(Scene scene)
        {
            string warning;
            IntPtr handle = Native.Made((out IntPtr tube, byte[] message, UIntPtr size) =>
                Native.tactus_tube_make(scene.Handle, out tube, message, size), out warning);
            GC.KeepAlive(scene);
            return handle;
        }

        /// A new placement at this depth, or at the end of the model's.
        public void Place(double depthMm)
        {
            Native.tactus_tube_place(Handle, depthMm);
            GC.KeepAlive(this);
        }

        /// Feels another scene, without a kick.
        public void Scene(Scene scene, double fadeS = 0.05)
        {
            Native.tactus_tube_scene(Handle, scene.Handle, fadeS);
            GC.KeepAlive(scene);
            GC.KeepAlive(this);
        }

        /// The largest stiffness and force to render; 0: none but the model's stiffness and the usual cap of 2 N.
        public void Limits(double stiffnessMaxNMm, double forceCapN = 0)
        {
            var limits = new Limits { Size = (UIntPtr)(uint)Marshal.SizeOf(typeof(Limits)),
                                      StiffnessMaxNMm = stiffnessMaxNMm, ForceCapN = forceCapN };
            Status status = Native.tactus_tube_limits(Handle, ref limits);
            GC.KeepAlive(this);
            if (status != Status.Ok)
                throw new Error(status, "limits: found one below 0 or not finite, wanted numbers from 0 on");
        }

        /// A position or a time out of range lets the tube go (phase 0).
        public Feel Step(double positionMm, bool held, double dtS)
        {
            Status status;
            return Step(positionMm, held, dtS, out status);
        }

        /// The same; `status` is then BadArgument.
        public Feel Step(double positionMm, bool held, double dtS, out Status status)
        {
            var feel = new Feel { Size = feel_size_ };
            status = Native.tactus_tube_step(Handle, positionMm, held ? 1 : 0, dtS, ref feel);
            GC.KeepAlive(this);
            return feel;
        }

        /// Another tube in the same state.
        public Tube Copy()
        {
            IntPtr copy;
            Status status = Native.tactus_tube_copy(Handle, out copy);
            GC.KeepAlive(this);
            if (status != Status.Ok) throw new Error(status, "copy: found too little memory for another tube");
            return new Tube(copy);
        }

        /// The state as bytes, for Load.
        public byte[] Save()
        {
            var bytes = new byte[SavedBytes];
            Save(bytes);
            return bytes;
        }

        /// How many bytes Save writes.
        public int SavedBytes
        {
            get
            {
                int size = (int)Native.tactus_tube_save(Handle, null, UIntPtr.Zero);
                GC.KeepAlive(this);
                return size;
            }
        }

        /// Writes the state into `bytes`, SavedBytes of them. Allocates nothing.
        public void Save(byte[] bytes)
        {
            int needed = (int)Native.tactus_tube_save(Handle, bytes, (UIntPtr)bytes.Length);
            GC.KeepAlive(this);
            if (needed > bytes.Length)
                throw new Error(Status.BadArgument, "save: found room for " + bytes.Length + " bytes, wanted " + needed);
        }

        /// Takes the state of a tube of the same model and the same fixed inputs: its next steps, bit by bit.
        public void Load(byte[] bytes)
        {
            Status status = Native.tactus_tube_load(Handle, bytes, (UIntPtr)(bytes == null ? 0 : bytes.Length));
            GC.KeepAlive(this);
            if (status != Status.Ok)
                throw new Error(status, "load: found bytes of another scene, model or version, or altered ones, " +
                                            "wanted those of a save");
        }

        internal override void Free(IntPtr handle) { Native.tactus_tube_free(handle); }
    }
}
