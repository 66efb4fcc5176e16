// What is seen beside the table: the room, out of focus.
varying vec3 eyeRay;

void main() {
  vec3 from = (gl_TextureMatrix[5] * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
  gl_FragColor = vec4(picture(roomLight(from, toWorld(normalize(eyeRay)), 0.18)), 1.0);
}
