// The averaged force of a model at one point: Force MODEL VALUE..., one value for each input.
// With Mono: mcs Force.cs ../languages/Tactus.cs && mono Force.exe model.tactus.json 1 45 30 30
using System;
using System.Globalization;

public static class Force
{
    public static int Main(string[] arguments)
    {
        if (arguments.Length == 0)
        {
            Console.Error.WriteLine("usage: Force MODEL VALUE...");
            return 2;
        }
        try
        {
            using (var model = Tactus.Model.Open(arguments[0]))
            {
                var inputs = new double[arguments.Length - 1];
                for (int i = 0; i < inputs.Length; ++i)
                {
                    // Without the style "0,5" would be 5: a comma between thousands.
                    if (double.TryParse(arguments[i + 1], NumberStyles.Float, CultureInfo.InvariantCulture, out inputs[i])) continue;
                    Console.Error.WriteLine("found '" + arguments[i + 1] + "', wanted a number with a decimal point");
                    return 2;
                }
                bool fired;
                double forceN = model.Force(inputs, out fired);
                Console.WriteLine(forceN.ToString("R", CultureInfo.InvariantCulture) + " N" +
                                  (fired ? "" : " (no rule fires: the model's default)"));
            }
            return 0;
        }
        catch (Tactus.Error error)
        {
            Console.Error.WriteLine(error.Message);
            return 1;
        }
    }
}
