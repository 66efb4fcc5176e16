// Vertex stage of the laparoscope's mask: a quad before everything. at: 1 at the picture's upper border.
varying vec2 at;

void main() {
  vec2 corner = sign(gl_Vertex.xy);
  at = corner * vec2(gl_ProjectionMatrix[1][1] / gl_ProjectionMatrix[0][0], 1.0);
  gl_Position = vec4(corner, -0.999999, 1.0);
}
