// A drop of blood: a dark red ball with a glint, on a point.
void main() {
  vec2 q = 2.0 * gl_PointCoord - 1.0;
  float r = dot(q, q);
  if (r > 1.0) discard;
  float glint = smoothstep(0.25, 0.0, length(q - vec2(-0.3, -0.35)));
  gl_FragColor = vec4(vec3(0.36, 0.02, 0.02) * (1.0 - 0.5 * r) + 0.55 * glint, 1.0);
}
