#include <CGAL/Geometric_continuity/curves/evaluate_batch.h> // moved
