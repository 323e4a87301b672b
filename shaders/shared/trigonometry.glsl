// Sine and cosine of one angle together.
//
// Where waves are summed in every pixel, a sine and a cosine of the same angle are most of the work. A driver works each out
// on its own, with its own reduction of the range; together they need one, and half the angle needs short polynomials only.

// Sine and cosine of an angle in radians, each within 7e-7 within a turn; of larger ones the reduction takes digits, about
// 8e-8 of the angle, as the rounding of the angle itself does.
// With y half the angle, brought to -pi/2 … pi/2: sin y and cos y by polynomials with an error of 2e-9 (Hastings 1955, as
// Abramowitz & Stegun 1964 print them, 4.3.97 and 4.3.99), then sin 2y = 2 sin y cos y and cos 2y = 1 - 2 sin² y.
SHARED vec2 sinCosTogether(float angle)
{
    const float turnsPerRadian = 0.15915494309189535;
    const float pi = 3.14159265358979324;
    float turns = angle * turnsPerRadian;
    float y = pi * (turns - floor(turns + 0.5));
    float t = y * y;
    float s = y * (1.0 + t * (-0.1666666664 + t * (0.0083333315 + t * (-0.0001984090 + t * (0.0000027526 - t * 0.0000000239)))));
    float c = 1.0 + t * (-0.4999999963 + t * (0.0416666418 + t * (-0.0013888397 + t * (0.0000247609 - t * 0.0000002605))));
    return vec2(2.0 * s * c, 1.0 - 2.0 * s * s);
}
