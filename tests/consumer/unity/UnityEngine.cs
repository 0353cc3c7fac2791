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

    public static class Debug
    {
        public static string warned;
        public static void LogWarning(object message) { warned = message.ToString(); }
    }

    public struct Vector3
    {
        public float x, y, z;
    }

    public struct Rect
    {
        public Rect(float x, float y, float width, float height) { }
    }

    public static class Input
    {
        public static Vector3 mousePosition;
        public static bool pressed;
        public static bool GetMouseButton(int button) { return pressed; }
    }

    public static class GUI
    {
        public static string shown;
        public static void Label(Rect place, string text) { shown = text; }
    }
}
