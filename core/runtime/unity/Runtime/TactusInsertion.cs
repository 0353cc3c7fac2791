// An insertion in Unity: the driver of the device sets position and button, and reads the force, at 1 kHz.
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using UnityEngine;

namespace Tactus
{
    public sealed class TactusInsertion : MonoBehaviour
    {
        [Tooltip("Name of the model file in StreamingAssets")]
        public string modelFile = "model.tactus.json";
        public double lubrication = 1.0;
        public double neckFlexionDeg = 45.0;
        [Tooltip("Off: the driver of the device calls Step in its own callback")]
        public bool ownThread = true;

        private Model model_;
        private Tube tube_;
        private Thread thread_;
        private volatile bool running_;
        private double positionM_, forceN_, depthMm_;
        private volatile bool held_;

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

        /// One step of the insertion, from one thread. Allocates nothing.
        public double Step(double dtS)
        {
            Feel feel = tube_.Step(1000 * PositionM, held_, dtS);
            Volatile.Write(ref depthMm_, feel.DepthMm);
            Volatile.Write(ref forceN_, feel.ForceN);
            return feel.ForceN;
        }

        private void OnEnable()
        {
            model_ = Model.Open(Path.Combine(Application.streamingAssetsPath, modelFile));
            var conditions = new Dictionary<string, double> { { "lubrication", lubrication }, { "neck_flexion", neckFlexionDeg } };
            // The tube keeps what it needs of the scene.
            using (var scene = model_.Scene(conditions)) tube_ = new Tube(scene);
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
            if (tube_ != null) tube_.Dispose();
            if (model_ != null) model_.Dispose();
            Volatile.Write(ref forceN_, 0);
        }

        private void Run()
        {
            var clock = Stopwatch.StartNew();
            double last = 0;
            while (running_)
            {
                double now = clock.Elapsed.TotalSeconds;
                if (now - last < 0.001)
                {
                    Thread.SpinWait(50);
                    continue;
                }
                Step(now - last);
                last = now;
            }
        }
    }
}
