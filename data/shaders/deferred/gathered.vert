// A quad over the picture; its colour is the organ's.
varying vec3 baseColor;

void main() {
  baseColor = gl_Color.rgb;
  gl_Position = gl_Vertex;
}
