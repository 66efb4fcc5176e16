// Vertex stage of the organ: like surface.vert, with rest position and cut from SoOrganShape.
varying vec3 eyePosition;
varying vec3 objectPosition;  // at rest, so that patterns stick to the tissue
varying vec3 objectNormal;
varying float cutShare;
varying vec3 baseColor;

void main() {
  vec4 eye = gl_ModelViewMatrix * gl_Vertex;
  eyePosition = eye.xyz;
  objectPosition = gl_MultiTexCoord1.xyz;
  objectNormal = gl_Normal;
  baseColor = gl_Color.rgb;
  cutShare = gl_MultiTexCoord2.x;
  gl_Position = gl_ProjectionMatrix * eye;
}
