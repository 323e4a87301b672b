// The yardstick of benchmarks: a mesh with one picture on it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 textureUv;

uniform mat4 clipFromWorld;

out vec2 uv;

void main()
{
    uv = textureUv;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
