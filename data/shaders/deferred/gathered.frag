// Liver, shaded pixel by pixel from what gather.frag left.
uniform sampler2D places, bends;
uniform vec2 texel;     // size of one, as a share of the textures
uniform vec4 viewport;  // pixels: left, bottom, width, height
varying vec3 baseColor;

const float kMeanBend = 20.0;  // 1/m: of a liver

void main() {
  vec2 at = gl_FragCoord.xy * texel;
  vec4 place = texture2D(places, at), bend = texture2D(bends, at);
  float z = bend.z;
  vec3 n = vec3(bend.xy, 1.0 - abs(bend.x) - abs(bend.y));
  float under = max(-n.z, 0.0);
  n.xy += vec2(n.x < 0.0 ? under : -under, n.y < 0.0 ? under : -under);
  vec2 ndc = 2.0 * (gl_FragCoord.xy - viewport.xy) / viewport.zw - 1.0;
  mat4 p = gl_ProjectionMatrix;
  vec3 eye = vec3(-z * (ndc.x + p[2][0]) / p[0][0], -z * (ndc.y + p[2][1]) / p[1][1], z);
  gl_FragColor = vec4(liver(place.xyz, bend.w, normalize(n), kMeanBend, place.w, eye, baseColor), 1.0);
}
