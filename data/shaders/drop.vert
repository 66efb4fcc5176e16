// Vertex stage of drops of blood: points.
void main() { gl_Position = ftransform(); }
