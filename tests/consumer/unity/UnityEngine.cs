// A stand-in for the few names of UnityEngine that the package uses, so that it compiles and runs without Unity.
using System;

namespace UnityEngine
{
    public class MonoBehaviour { }

    public sealed class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string text) { }
    }

    public static class Application
    {
        public static string streamingAssetsPath;
    }
}
