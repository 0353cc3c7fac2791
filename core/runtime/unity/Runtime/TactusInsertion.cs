// An insertion in Unity: the driver of the device sets position and button, and reads the force, at 1 kHz.
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using UnityEngine;

namespace Tactus
{
    /// An input of the model that the hand does not move.
    [Serializable]
    public sealed class Condition
    {
        public string id;
        public double value;
    }

    public sealed class TactusInsertion : MonoBehaviour
    {
        [Tooltip("Name of the model file in StreamingAssets")]
        public string modelFile = "model.tactus.json";
        [Tooltip("Inputs of the model and their values; an input that is missing here has the middle of its range")]
        public List<Condition> conditions = new List<Condition>
        {
            new Condition { id = "lubrication", value = 1.0 },
            new Condition { id = "neck_flexion", value = 45.0 },
        };
        [Tooltip("Largest stiffness that the loop can take, N/mm; 0: the model's")]
        public double stiffnessMaxNMm = 0;
        [Tooltip("Largest force, N; 0: the usual 2 N")]
        public double forceCapN = 0;
        [Tooltip("Off: the driver of the device calls Step in its own callback")]
        public bool ownThread = true;

        /// The id of the depth term at the tip of the tube, or null. Unity's thread.
        public event Action<string> RegionChanged;
        /// Whether no rule fires there, so that the last force is held. Unity's thread.
        public event Action<bool> HeldLastChanged;
        /// The tube lets go by itself and holds again after Held was false; with the reason. Unity's thread.
        public event Action<string> LetGo;

        private sealed class Change
        {
            internal Scene Scene;
            internal double FadeS;
        }

        private const double PeriodS = 0.001, SpinS = 0.0002;
        private const int NoRegion = -1;

        private Model model_;
        private Tube tube_;
        private Thread thread_;
        private int depth_;
        private readonly Dictionary<string, double> values_ = new Dictionary<string, double>();
        private volatile bool running_;
        private double positionM_, forceN_, depthMm_;
        private volatile bool held_, heldLast_, letGo_;
        private volatile int region_ = NoRegion;
        private Change next_;   // for the thread of the steps
        private Change felt_;   // touched by the thread of the steps alone
        private Change done_;   // felt before; freed by Unity's thread
        private int toldRegion_ = NoRegion;
        private bool toldHeldLast_;

        /// Of the tool along the path of insertion, inwards positive, m.
        public double PositionM
        {
            get { return Volatile.Read(ref positionM_); }
            set { Volatile.Write(ref positionM_, value); }
        }

        /// Whether the hand holds the tube.
        public bool Held { get { return held_; } set { held_ = value; } }

        /// On the hand, > 0 pushes it out.
        public double ForceN { get { return Volatile.Read(ref forceN_); } }

        /// Of the tube.
        public double DepthMm { get { return Volatile.Read(ref depthMm_); } }

        /// The depth term at the tip, or null.
        public string Region { get { return Word(model_ == null ? null : model_.TermIds); } }

        /// The same as the model names it on a screen.
        public string RegionLabel { get { return Word(model_ == null ? null : model_.TermLabels); } }

        /// The model that runs; null while the component is disabled.
        public Model Model { get { return model_; } }

        /// Changes a condition in the hand without a kick, within `fadeS` seconds. Unity's thread.
        public void SetCondition(string id, double value, double fadeS = 0.05)
        {
            if (model_ == null) throw new ObjectDisposedException(GetType().FullName, "the component is disabled");
            if (!values_.ContainsKey(id))
                throw new Error(Status.BadArgument, "condition: found '" + id + "', wanted one of " +
                                                        string.Join(", ", new List<string>(values_.Keys)));
            double before = values_[id];
            values_[id] = value;
            Scene scene;
            try { scene = model_.Scene(values_); }
            catch { values_[id] = before; throw; }
            Free(Interlocked.Exchange(ref done_, null));
            Free(Interlocked.Exchange(ref next_, new Change { Scene = scene, FadeS = fadeS }));
        }

        /// One step of the insertion, from one thread. Allocates nothing.
        public double Step(double dtS)
        {
            Change next = Interlocked.Exchange(ref next_, null);
            if (next != null)
            {
                tube_.Scene(next.Scene, next.FadeS);
                // The scene before is freed by Unity's thread, or here if that has not come by since the last one.
                Free(Interlocked.Exchange(ref done_, felt_));
                felt_ = next;
            }
            Status status;
            Feel feel = tube_.Step(1000 * PositionM, held_, dtS, out status);
            if (status != Status.Ok) letGo_ = true;
            heldLast_ = feel.HeldLast != 0;
            region_ = feel.Region;
            Volatile.Write(ref depthMm_, feel.DepthMm);
            Volatile.Write(ref forceN_, feel.ForceN);
            return feel.ForceN;
        }

        private void OnEnable()
        {
            model_ = Model.Open(Path.Combine(Application.streamingAssetsPath, modelFile));
            depth_ = Array.IndexOf(model_.InputIds, "depth");
            values_.Clear();
            for (int i = 0; i < model_.Inputs; ++i)
            {
                string id = model_.InputIds[i];
                if (id != "depth" && id != "speed") values_[id] = (model_.InputMin[i] + model_.InputMax[i]) / 2;
            }
            foreach (Condition condition in conditions)
            {
                if (values_.ContainsKey(condition.id)) values_[condition.id] = condition.value;
                else UnityEngine.Debug.LogWarning("Tactus: the model has no condition '" + condition.id + "'");
            }
            felt_ = new Change { Scene = model_.Scene(values_) };
            tube_ = new Tube(felt_.Scene);
            tube_.Limits(stiffnessMaxNMm, forceCapN);
            if (!ownThread) return;
            running_ = true;
            thread_ = new Thread(Run) { IsBackground = true, Priority = System.Threading.ThreadPriority.Highest };
            thread_.Start();
        }

        private void OnDisable()
        {
            running_ = false;
            if (thread_ != null) thread_.Join();
            thread_ = null;
            Free(Interlocked.Exchange(ref next_, null));
            Free(Interlocked.Exchange(ref done_, null));
            Free(felt_);
            felt_ = null;
            if (tube_ != null) tube_.Dispose();
            if (model_ != null) model_.Dispose();
            tube_ = null;
            model_ = null;
            region_ = NoRegion;
            Volatile.Write(ref forceN_, 0);
        }

        private void Update()
        {
            int region = region_;
            if (region != toldRegion_)
            {
                toldRegion_ = region;
                if (RegionChanged != null) RegionChanged(Region);
            }
            bool heldLast = heldLast_;
            if (heldLast != toldHeldLast_)
            {
                toldHeldLast_ = heldLast;
                if (HeldLastChanged != null) HeldLastChanged(heldLast);
            }
            if (!letGo_) return;
            letGo_ = false;
            const string reason = "Tactus: the tube was let go after a pause of more than a second, or a position that is none; " +
                                  "release it and press again";
            UnityEngine.Debug.LogWarning(reason);
            if (LetGo != null) LetGo(reason);
        }

        private string Word(string[][] words)
        {
            int region = region_;
            return words != null && depth_ >= 0 && region >= 0 && region < words[depth_].Length ? words[depth_][region] : null;
        }

        private static void Free(Change change)
        {
            if (change != null) change.Scene.Dispose();
        }

        private void Run()
        {
            var clock = Stopwatch.StartNew();
            double last = 0;
            while (running_)
            {
                double now = clock.Elapsed.TotalSeconds;
                double left = PeriodS - (now - last);
                if (left > 0)
                {
                    // Other threads run until shortly before the step; a sleep of a millisecond would be too long.
                    if (left > SpinS) Thread.Sleep(0);
                    else Thread.SpinWait(20);
                    continue;
                }
                Step(now - last);
                last = now;
            }
        }
    }
}
