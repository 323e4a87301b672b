// Between the depth buffer and view space, for OpenGL's perspective projection and a depth range of 0..1.

// View-space z (negative in front of the camera) of a depth-buffer value.
// Written as a weighted sum, not as f - d (f - n): that difference loses all digits of n where d is close to 1 and
// the far plane is far.
SHARED float viewZFromDepth(float depth01, float nearPlane, float farPlane)
{
    return -nearPlane * farPlane / (farPlane * (1.0 - depth01) + nearPlane * depth01);
}

// The inverse: depth-buffer value of a view-space z, which must be negative.
SHARED float depthFromViewZ(float viewZ, float nearPlane, float farPlane)
{
    return farPlane * (viewZ + nearPlane) / (viewZ * (farPlane - nearPlane));
}

// How much view-space distance one unit of depth spans at viewZ, per unit: |dz/dd|. Times 2^-24 it is the resolution
// of a 24-bit depth buffer in metres.
SHARED float viewZPerDepth(float viewZ, float nearPlane, float farPlane)
{
    return viewZ * viewZ * (farPlane - nearPlane) / (nearPlane * farPlane);
}
