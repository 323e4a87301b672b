// The mean of the frames so far; `part` is the weight of the newest (render/passes/accumulate.h).
uniform sampler2D newest;
uniform sampler2D mean;
uniform float part;

out vec4 fragment;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    fragment = mix(texelFetch(mean, at, 0), texelFetch(newest, at, 0), part);
}
