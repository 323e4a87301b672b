// The yardstick of benchmarks: one texture fetch, no light.
in vec2 uv;

uniform sampler2D picture;

out vec4 fragment;

void main()
{
    fragment = texture(picture, uv);
}
