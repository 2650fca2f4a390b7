#include <CGAL/Geometric_continuity/models/model_continuity.h> // moved
