// Vertex stage of the background: a quad over the whole picture, behind everything.
varying vec3 eyeRay;

void main() {
  vec2 corner = sign(gl_Vertex.xy);
  vec4 eye = gl_ProjectionMatrixInverse * vec4(corner, 1.0, 1.0);
  eyeRay = eye.xyz / eye.w;
  gl_Position = vec4(corner, 0.999999, 1.0);
}
