// What is seen beside the table: the room, out of focus, darker towards the corners.
varying vec3 eyeRay;

void main() {
  vec3 d = toWorld(normalize(eyeRay));
  gl_FragColor = vec4(picture(0.55 * roomLight(d, 0.30)), 1.0);
}
