// The forces of a table that table.c wrote as bits, once more by Tactus.cs: Table MODEL BITS.csv BUNDLE.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

public static class Table
{
    static void Want(bool condition, string what)
    {
        if (!condition) throw new Exception(what);
    }

    static double Number(string bits)
    {
        return BitConverter.Int64BitsToDouble((long)ulong.Parse(bits, NumberStyles.HexNumber));
    }

    public static void Main(string[] arguments)
    {
        using (var model = Tactus.Model.Open(arguments[0]))
        {
            int points = 0;
            foreach (string line in File.ReadLines(arguments[1]))
            {
                string[] cells = line.Split(',');
                var inputs = new double[model.Inputs];
                for (int k = 0; k < inputs.Length; ++k) inputs[k] = Number(cells[k]);
                bool fired;
                double forceN = model.Force(inputs, out fired);
                Want(BitConverter.DoubleToInt64Bits(forceN) == BitConverter.DoubleToInt64Bits(Number(cells[inputs.Length])) &&
                         fired == (cells[inputs.Length + 1] == "1"), "another force than in C: " + line);
                ++points;
            }
            Console.WriteLine(points + " forces as in C");
            var conditions = new Dictionary<string, double> { { "lubrication", 1 }, { "neck_flexion", 45 } };
            using (var scene = model.Scene(conditions))
            using (var tube = new Tactus.Tube(scene))
            {
                var point = new double[] { 1, 45, 30, 30 };
                Want(scene.Force(new double[] { 30, 30 }) == model.Force(point), "a scene differs from its model");
                var batch = new double[2];
                model.ForceBatch(new double[] { 1, 45, 30, 30, 1, 45, 30, 30 }, batch, null);
                Want(Math.Abs(batch[1] - model.Force(point)) < 1e-15, "a batch differs from its points");
                Want(model.Clamped(new double[] { 2, 45, 30, -1 }) == 9, "clamped");
                Want(model.ExpertForce(0, point) == model.Force(point), "the only expert");
                tube.Place(10);
                Tactus.Feel feel = new Tactus.Feel();
                for (int i = 0; i < 400; ++i) feel = tube.Step(0.05 * i, true, 0.001);
                Want(feel.Phase == 2 && feel.ForceN > 0 && feel.Stroke == 1, "the tube does not slide");
                tube.Scene(scene);
            }
            Want(Tactus.Bundle.Verify(arguments[2]) == 0, "a bundle with an error");
            try
            {
                Tactus.Model.Read("{}");
                Want(false, "no error");
            }
            catch (Tactus.Error error)
            {
                Want(error.Status == Tactus.Status.BadFile && error.Message.Length > 0, "no sentence");
            }
        }
    }
}
