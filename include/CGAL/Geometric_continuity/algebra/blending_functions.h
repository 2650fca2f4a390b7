#include <CGAL/Geometric_continuity/algebra/Basis_matrix.h> // moved
