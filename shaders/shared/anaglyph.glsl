// Two eyes' pictures as one, for glasses with a red filter before the left eye and a cyan one before the right.

// Dubois 2001 ("A projection method to generate anaglyph stereo images"): of all pictures that a screen can show, the one
// that comes nearest, by least squares in CIE XYZ, to what each eye should see, filters and screen taken together; the
// matrix is his for common red-cyan glasses. Equal grey stays what it is: each row sums to 1.
// left, right: linear 0..1 after the tone curve. Result: the same; what a screen cannot show is cut off.
SHARED vec3 anaglyphRedCyan(vec3 left, vec3 right)
{
    vec3 sum = vec3(0.4561, -0.0400822, -0.0152161) * left.x + vec3(0.500484, -0.0378246, -0.0205971) * left.y +
               vec3(0.176381, -0.0157589, -0.00546856) * left.z + vec3(-0.0434706, 0.378476, -0.0721527) * right.x +
               vec3(-0.0879388, 0.73364, -0.112961) * right.y + vec3(-0.00155529, -0.0184503, 1.2264) * right.z;
    return clamp(sum, vec3(0.0), vec3(1.0));
}
