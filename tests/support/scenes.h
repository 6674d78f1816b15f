// Scenes made in code.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vct::test {

constexpr double pi = 3.14159265358979323846;

// One white, single-sided material and no geometry.
Scene emptyScene();

// Adds the rectangle corner, corner + u, corner + u + v, corner + v; its front is on the side of cross(u, v).
void addQuad(Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
             int material = 0);

// Adds a closed box with sides along the axes around `centre`, its outside the front, as one mesh.
void addBox(Scene& scene, const glm::dvec3& sides, const glm::dvec3& centre = glm::dvec3(0.0),
            int material = 0);

// Adds a ball of 64 x 32 rectangles, smooth.
void addBall(Scene& scene, double radius, const glm::dvec3& centre, int material = 0);

// Turns everything around an axis through the origin, and returns the rotation.
glm::dmat4 turnScene(Scene& scene, double angleDeg, const glm::dvec3& axis = {1, 2, 3});

// A cube of side 2 around the origin whose inside is the front; turned by `angleDeg`.
Scene closedBox(double angleDeg);

// A square of side 2 in the plane y = 0, facing up; turned by `angleDeg`.
Scene lonePlane(double angleDeg);

// A room of 24 x 6 x 8 m, seen from inside, with a panel that emits light in its ceiling.
Scene hall();

// Permutes the instances, and the triangles of every mesh. The order of vertices within a triangle stays.
void shuffleTriangles(Scene& scene, unsigned seed);

// Computes the bounds; call when all geometry is there.
Scene finished(Scene scene);

DirectionalLight lightFrom(const glm::dvec3& directionToLight);
// For scenes with light from emitters or the sky alone.
DirectionalLight noLight();

}  // namespace vct::test
