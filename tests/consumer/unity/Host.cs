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
        Send(called, "OnDisable");
        Want(called.ForceN == 0, "a force after the end");

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
