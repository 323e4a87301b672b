// The mean of the edge x edge pixels that were drawn for one of the picture (frame.supersampling).
uniform sampler2D drawn;
uniform int edge;

out vec4 fragment;

void main()
{
    ivec2 first = edge * ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) sum += texelFetch(drawn, first + ivec2(x, y), 0);
    fragment = sum / float(edge * edge);
}
