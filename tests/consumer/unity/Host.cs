// What Unity and the driver of a device do with the component: Host STREAMING_ASSETS.
using System;
using System.Reflection;
using System.Threading;

public static class Host
{
    static void Send(object component, string message)
    {
        component.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(component, null);
    }

    static void Want(bool condition, string what)
    {
        if (!condition) throw new Exception(what);
    }

    public static void Main(string[] arguments)
    {
        UnityEngine.Application.streamingAssetsPath = arguments[0];
        // Called by the driver's own callback.
        var called = new Tactus.TactusInsertion { ownThread = false };
        Send(called, "OnEnable");
        called.Held = true;
        double largestN = 0;
        for (int tick = 0; tick < 1000; ++tick)
        {
            called.PositionM = 0.00006 * tick;
            largestN = Math.Max(largestN, called.Step(0.001));
        }
        Want(largestN > 0.05 && largestN < 1.1 && called.DepthMm > 50 && called.DepthMm < 60, "called: " + largestN);
        // What the scene shows, and another condition in the hand: no kick, and after the fade the force of that scene.
        string region = null, reason = null;
        called.RegionChanged += id => region = id;
        called.LetGo += why => reason = why;
        Send(called, "Update");
        Want(region == "nasal_cavity" && called.RegionLabel == "nasal_cavity", "region: " + region + ", " + called.RegionLabel);
        double before = called.ForceN, largestStepN = 0;
        called.SetCondition("lubrication", 0, 0.5);
        for (int tick = 0; tick < 2000; ++tick)
        {
            called.PositionM += 0.00003;
            double forceN = called.Step(0.001);
            largestStepN = Math.Max(largestStepN, Math.Abs(forceN - before));
            before = forceN;
            if (tick % 100 == 50) called.SetCondition("neck_flexion", 45 - 0.01 * tick, 0.1);
        }
        Want(largestStepN < 0.03 && before > largestN, "another condition: " + largestStepN + ", " + before);
        foreach (string wrong in new[] { "depth", "swallow", "" })
        {
            try { called.SetCondition(wrong, 1); }
            catch (Tactus.Error) { continue; }
            throw new Exception("condition " + wrong);
        }
        called.Step(5);
        Send(called, "Update");
        Want(reason != null && UnityEngine.Debug.warned == reason, "a pause without a word");
        Send(called, "OnDisable");
        Want(called.ForceN == 0 && called.Region == null, "a force after the end");
        // The mouse in the place of a device; a model with an input more than the list of conditions.
        var fifth = new Tactus.TactusInsertion { ownThread = false, modelFile = "swallow.tactus.json" };
        Send(fifth, "OnEnable");
        fifth.SetCondition("swallow", 1);
        var mouse = new Tactus.MouseInsertion { insertion = fifth };
        UnityEngine.Input.pressed = true;
        for (int tick = 0; tick < 400; ++tick)
        {
            UnityEngine.Input.mousePosition.y = tick;
            Send(mouse, "Update");
            fifth.Step(0.001);
        }
        Send(mouse, "OnGUI");
        Want(fifth.ForceN > 0 && fifth.DepthMm > 50 && UnityEngine.GUI.shown.Contains(" N at "), "mouse");
        Send(fifth, "OnDisable");

        // By the component's own thread, while this one moves the hand at 60 mm/s.
        var own = new Tactus.TactusInsertion { ownThread = true, Held = true };
        Send(own, "OnEnable");
        var clock = System.Diagnostics.Stopwatch.StartNew();
        while (own.ForceN < 0.05 && own.PositionM < 0.6)
        {
            own.PositionM = 0.06 * clock.Elapsed.TotalSeconds;
            Thread.Yield();
        }
        Want(own.ForceN > 0, "no force from the thread");
        Send(own, "OnDisable");
        Console.WriteLine("the insertion is felt");
    }
}
