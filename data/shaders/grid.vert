// Vertex stage of SoShadowMaps' grid: a quad over all of it.
varying vec2 at;  // -1..1: x right, y away from the surgeon

void main() {
  at = gl_Vertex.xy;
  gl_Position = gl_Vertex;
}
