// The live link in C#: Linked PORT TOKEN_FILE, beside `tactus serve` with the model that has the input `swallow`.
using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

public static class Linked
{
    static void Want(bool condition, string what)
    {
        if (!condition) throw new Exception(what);
    }

    static bool Soon(Func<bool> condition)
    {
        for (int i = 0; i < 2000; ++i)
        {
            if (condition()) return true;
            Thread.Sleep(10);
        }
        return false;
    }

    public static void Main(string[] arguments)
    {
        int port = int.Parse(arguments[0]);
        string token = File.ReadAllLines(arguments[1])[0];
        using (var link = new Tactus.Link(port, token, "a \"simulator\" \\ in C#"))
        {
            Want(link.Program.StartsWith("tactus "), "program: " + link.Program);
            string text = null;
            int serial = 0;
            Want(Soon(() => link.TakeModel(out text, out serial)), "no model");
            using (var model = Tactus.Model.Read(text)) Want(serial == 1 && model.Inputs == 5, "another model");
            Want(!link.TakeModel(out text, out serial), "a model twice");
            for (int i = 0; i < 20000; ++i)
                link.Felt(i * 0.001, i * 0.001, 20, 0.3, new Dictionary<string, double> { { "swallow", 0.5 } });
            foreach (double wrong in new[] { double.NaN, double.PositiveInfinity })
            {
                try { link.Felt(0, wrong, 0, 0, null); }
                catch (Tactus.Error) { continue; }
                throw new Exception("no error");
            }
            Thread.Sleep(50);
            Want(!link.Ended && link.ErrorSentence == null, "ended: " + link.ErrorSentence);
            link.Felt(1, 2, 3, 4, new Dictionary<string, double> { { "mouth", 1 } });
            Want(Soon(() => link.Ended) && link.ErrorSentence.Contains("found 'mouth'"), "no sentence: " + link.ErrorSentence);
        }
        try { new Tactus.Link(port, "wrong", "x"); }
        catch (Tactus.Error error)
        {
            Want(error.Message.Contains("token"), error.Message);
            Console.WriteLine("linked");
            return;
        }
        throw new Exception("a wrong token");
    }
}
