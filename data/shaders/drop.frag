// A point of a streak of blood. Points overlap to a line, so they have neither glint nor shade.
void main() {
  vec2 q = 2.0 * gl_PointCoord - 1.0;
  if (dot(q, q) > 1.0) discard;
  gl_FragColor = vec4(0.46, 0.035, 0.032, 1.0);
}
