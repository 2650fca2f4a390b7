#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h> // moved
