// What Tactus.cs offers beside forces, on the model of S4: Uses MODEL BUNDLE.
using System;
using System.Collections.Generic;

public static class Uses
{
    static void Want(bool condition, string what)
    {
        if (!condition) throw new Exception(what);
    }

    public static void Main(string[] arguments)
    {
        using (var model = Tactus.Model.Open(arguments[0]))
        {
            var conditions = new Dictionary<string, double> { { "lubrication", 1 }, { "neck_flexion", 45 } };
            using (var scene = model.Scene(conditions))
            using (var tube = new Tactus.Tube(scene))
            {
                var point = new double[] { 1, 45, 30, 30 };
                Want(scene.Force(new double[] { 30, 30 }) == model.Force(point), "a scene differs from its model");
                Want(model.Clamped(new double[] { 2, 45, 30, -1 }) == 9, "clamped");
                Want(model.ExpertForce(0, point) == model.Force(point), "the only expert");
                tube.Place(10);
                Tactus.Feel feel = new Tactus.Feel();
                for (int i = 0; i < 400; ++i) feel = tube.Step(0.05 * i, true, 0.001);
                Want(feel.Phase == 2 && feel.ForceN > 0 && feel.Stroke == 1, "the tube does not slide");
                tube.Scene(scene);
            }
            Want(Tactus.Bundle.Verify(arguments[1]) == 0, "a bundle with an error");
            Refused(() => Tactus.Model.Read("{}"), Tactus.Status.BadFile);
            Refused(() => model.Force(new double[] { 1, 2 }), Tactus.Status.BadArgument);
            Refused(() => model.Scene(new Dictionary<string, double> { { "swallow", 1 } }), Tactus.Status.BadArgument);
        }
        Console.WriteLine("used");
    }

    static void Refused(Action wrong, Tactus.Status status)
    {
        try
        {
            wrong();
        }
        catch (Tactus.Error error)
        {
            Want(error.Status == status && error.Message.Length > 0, "no sentence");
            return;
        }
        Want(false, "no error");
    }
}
