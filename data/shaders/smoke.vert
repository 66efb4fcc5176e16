// Vertex stage of smoke: squares that face the eye.
varying vec3 eyePosition;
varying vec2 corner;    // -1 to 1
varying vec3 pattern;   // place in the smoke's pattern
varying float density;

void main() {
  vec4 eye = gl_ModelViewMatrix * gl_Vertex;
  eye.xy += gl_MultiTexCoord1.z * gl_MultiTexCoord1.xy;
  eyePosition = eye.xyz;
  corner = gl_MultiTexCoord1.xy;
  density = gl_MultiTexCoord1.w;
  // The pattern widens with the ball and rises with it.
  pattern = vec3(corner, 0.0) * (0.9 + 40.0 * gl_MultiTexCoord1.z) + 35.0 * gl_Vertex.xyz;
  gl_Position = gl_ProjectionMatrix * eye;
}
