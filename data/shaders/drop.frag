// A point of a streak of blood. Points overlap, so they have no glint: in a row it would look like beads.
void main() {
  vec2 q = 2.0 * gl_PointCoord - 1.0;
  float r = dot(q, q);
  if (r > 1.0) discard;
  gl_FragColor = vec4(vec3(0.36, 0.02, 0.02) * (1.0 - 0.4 * r), 1.0);
}
