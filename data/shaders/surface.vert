// Vertex stage of every surface: positions and normals in object and eye space.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

void main() {
  vec4 eye = gl_ModelViewMatrix * gl_Vertex;
  eyePosition = eye.xyz;
  objectPosition = gl_Vertex.xyz;
  objectNormal = gl_Normal;
  baseColor = gl_Color.rgb;
  gl_Position = gl_ProjectionMatrix * eye;
}
