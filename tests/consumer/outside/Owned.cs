// Handles in C#: what is miscounted, disposed and used afterwards throws, and never gives 0 N. Owned.exe MODEL
using System;
using System.Collections.Generic;

internal static class Owned
{
    private static void Refused<T>(Action call) where T : Exception
    {
        try { call(); }
        catch (T) { return; }
        throw new Exception("not refused");
    }

    private static int Main(string[] arguments)
    {
        double[] point = {1, 45, 30, 30}, few = {1, 45, 30}, many = {1, 45, 30, 30, 30};
        var model = Tactus.Model.Open(arguments[0]);
        var fixedInputs = new Dictionary<string, double> {{"lubrication", 1.0}, {"neck_flexion", 45.0}};
        var scene = model.Scene(fixedInputs);
        var tube = new Tactus.Tube(scene);
        foreach (double[] wrong in new[] {few, many, null})
        {
            Refused<Tactus.Error>(() => model.Force(wrong));
            Refused<Tactus.Error>(() => model.ExpertForce(0, wrong));
            Refused<Tactus.Error>(() => model.ForceBatch(wrong, new double[1], null));
            Refused<Tactus.Error>(() => model.Clamped(wrong));
            Refused<Tactus.Error>(() => scene.Force(wrong));
        }
        foreach (int expert in new[] {-1, model.ExpertIds.Length, int.MaxValue})
            Refused<Tactus.Error>(() => model.ExpertForce(expert, point));
        if (!(model.Force(point) > 0)) throw new Exception("no force");
        for (int i = 0; i < 2; ++i)
        {
            model.Dispose();
            scene.Dispose();
        }
        tube.Step(1, true, 0.001);  // has what it needs
        tube.Dispose();
        tube.Dispose();
        Refused<ObjectDisposedException>(() => model.Force(point));
        Refused<ObjectDisposedException>(() => model.ExpertForce(0, point));
        Refused<ObjectDisposedException>(() => model.ForceBatch(point, new double[1], null));
        Refused<ObjectDisposedException>(() => model.Clamped(point));
        Refused<ObjectDisposedException>(() => model.Scene(fixedInputs));
        Refused<ObjectDisposedException>(() => scene.Force(new double[] {30, 30}));
        Refused<ObjectDisposedException>(() => scene.ForceBatch(new double[] {30, 30}, new double[1], null));
        Refused<ObjectDisposedException>(() => new Tactus.Tube(scene));
        Refused<ObjectDisposedException>(() => tube.Step(1, true, 0.001));
        Refused<ObjectDisposedException>(() => tube.Place(1));
        GC.Collect();
        Console.WriteLine("all of it");
        return 0;
    }
}
