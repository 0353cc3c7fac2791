// The mouse in the place of a device: upwards with the left button down pushes the tube in.
using UnityEngine;

namespace Tactus
{
    public sealed class MouseInsertion : MonoBehaviour
    {
        [Tooltip("The insertion that the mouse moves")]
        public TactusInsertion insertion;
        [Tooltip("Path of the hand for one pixel of the mouse, mm")]
        public float mmPerPixel = 0.25f;

        private float before_;

        private void Update()
        {
            float now = Input.mousePosition.y;
            insertion.PositionM += 0.001 * mmPerPixel * (now - before_);
            before_ = now;
            insertion.Held = Input.GetMouseButton(0);
        }

        private void OnGUI()
        {
            GUI.Label(new Rect(10, 10, 500, 30), string.Format("{0:F2} N at {1:F1} mm, {2}", insertion.ForceN, insertion.DepthMm,
                                                               insertion.RegionLabel ?? "in no region"));
        }
    }
}
