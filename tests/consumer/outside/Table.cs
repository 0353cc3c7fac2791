// The doubles that table.c wrote of a model, once more by Tactus.cs: Table MODEL ALL.
using System;
using System.Collections.Generic;
using System.IO;

public static class Table
{
    const int Group = 1000;  // points of one scene
    const int Fixed = 2;     // inputs that it fixes

    static void Same(double found, double wanted, string what, int point)
    {
        if (BitConverter.DoubleToInt64Bits(found) != BitConverter.DoubleToInt64Bits(wanted))
            throw new Exception(what + " is another one than in C at point " + point);
    }

    static double[] Doubles(string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        var values = new double[bytes.Length / sizeof(double)];
        Buffer.BlockCopy(bytes, 0, values, 0, bytes.Length);
        return values;
    }

    static double[] Part(double[] values, int first, int count)
    {
        var part = new double[count];
        Array.Copy(values, first, part, 0, count);
        return part;
    }

    public static void Main(string[] arguments)
    {
        double[] wanted = Doubles(arguments[1]);
        using (var model = Tactus.Model.Open(arguments[0]))
        {
            int row = model.Inputs + 6, count = wanted.Length / row;
            var all = new double[count * model.Inputs];
            for (int p = 0; p < count; ++p) Array.Copy(wanted, p * row, all, p * model.Inputs, model.Inputs);
            var batch = new double[count];
            var batchFired = new byte[count];
            model.ForceBatch(all, batch, batchFired);
            for (int first = 0; first < count; first += Group) Compare(model, wanted, batch, batchFired, first, Math.Min(Group, count - first));
            Console.WriteLine(count + " points as in C");
        }
    }

    static void Compare(Tactus.Model model, double[] wanted, double[] batch, byte[] batchFired, int first, int count)
    {
        int inputs = model.Inputs, row = inputs + 6, free = inputs - Fixed;
        var conditions = new Dictionary<string, double>();
        for (int i = 0; i < Fixed; ++i) conditions[model.InputIds[i]] = wanted[first * row + i];
        var rest = new double[count * free];
        for (int p = 0; p < count; ++p) Array.Copy(wanted, (first + p) * row + Fixed, rest, p * free, free);
        using (var scene = model.Scene(conditions))
        {
            var sceneBatch = new double[count];
            scene.ForceBatch(rest, sceneBatch, null);
            for (int p = 0; p < count; ++p)
            {
                int point = first + p, at = point * row + inputs;
                double[] values = Part(wanted, point * row, inputs);
                bool fired;
                Same(model.Force(values, out fired), wanted[at], "the force", point);
                Same(fired ? 1 : 0, wanted[at + 1], "fired", point);
                Same(batchFired[point], wanted[at + 1], "fired of the batch", point);
                Same(model.ExpertForce(model.ExpertIds.Length - 1, values), wanted[at + 2], "the last expert's force", point);
                Same(batch[point], wanted[at + 3], "the force of the batch", point);
                Same(scene.Force(Part(rest, p * free, free)), wanted[at + 4], "the force of the scene", point);
                Same(sceneBatch[p], wanted[at + 5], "the force of the scene's batch", point);
            }
        }
    }
}
