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
                Want(model.Clamped(new double[] { 2, 45, 30, -1 }) && !model.Clamped(point), "clamped");
                Want(model.ClampedInputs(new double[] { 2, 45, 30, -1 }) == 9, "which are clamped");
                Want(model.Sha256.Length == 64 && model.InputLabels[0] == "Tube lubrication", "words");
                Want(model.TermIds[0].Length == 3 && model.TermIds[0][1] == "medium", "terms");
                // The trapezoid of `poor` falls from 0.2 to 0.4.
                Want(Math.Abs(model.Membership(0, 0, 0, 0.25) - 0.75) < 1e-15, "membership");
                Refused(() => model.Membership(0, 0, 3, 0.25), Tactus.Status.BadArgument);
                Want(model.Renderer.StiffnessNMm > 0.1 && model.Renderer.SlewNS > 0, "renderer");
                Want(model.ExpertForce(0, point) == model.Force(point), "the only expert");
                tube.Place(10);
                Tactus.Feel feel = new Tactus.Feel();
                for (int i = 0; i < 400; ++i) feel = tube.Step(0.05 * i, true, 0.001);
                Want(feel.Phase == 2 && feel.ForceN > 0 && feel.Stroke == 1, "the tube does not slide");
                Want(model.TermIds[2][feel.Region] == "nasal_cavity" && feel.Limited == 0, "region");
                tube.Scene(scene);
                tube.Limits(0.1);
                byte[] state = tube.Save();
                using (Tactus.Tube copy = tube.Copy(), loaded = new Tactus.Tube(scene))
                {
                    loaded.Load(state);
                    feel = tube.Step(20, true, 0.001);
                    Want(feel.Limited == 1 && copy.Step(20, true, 0.001).ForceN == feel.ForceN &&
                             loaded.Step(20, true, 0.001).ForceN == feel.ForceN, "a copy goes another way");
                    state[state.Length / 2] ^= 1;
                    Refused(() => loaded.Load(state), Tactus.Status.BadArgument);
                    Refused(() => loaded.Load(null), Tactus.Status.BadArgument);
                    Refused(() => loaded.Limits(-1), Tactus.Status.BadArgument);
                    Refused(() => loaded.Save(new byte[3]), Tactus.Status.BadArgument);
                }
                Tactus.Status status;
                tube.Step(20, true, 5, out status);
                Want(status == Tactus.Status.BadArgument, "no status");
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
