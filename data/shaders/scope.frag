// What a laparoscope does not see: all round its round picture.
varying vec2 at;

void main() {
  if (dot(at, at) < 0.97 * 0.97) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0);
}
