/* SPDX-License-Identifier: CC0-1.0 */
/* Reads curves from standard input: dimension, degree, number of points, is it rational, knots, points
 * (homogeneous if rational). Prints for each span the position and derivatives at its start, evaluated
 * from the right, and at its end, evaluated from the left. */
#include <sisl.h>
#include <stdio.h>
#include <stdlib.h>

static int print_derivatives(SISLCurve* curve, int dimension, double t, int from_left, int order) {
  double values[16];
  int knot = 0, status = 0;
  if (from_left)
    s1227(curve, order, t, &knot, values, &status);
  else
    s1221(curve, order, t, &knot, values, &status);
  if (status < 0) return status;
  for (int i = 0; i < 4 * dimension; ++i) printf("%.17g ", i < (order + 1) * dimension ? values[i] : 0.0);
  return 0;
}

int main(void) {
  int dimension, degree, count, rational;
  while (scanf("%d %d %d %d", &dimension, &degree, &count, &rational) == 4) {
    const int n = count + degree + 1, size = count * (dimension + rational);
    double *knots = malloc(n * sizeof(double)), *points = malloc(size * sizeof(double));
    for (int i = 0; i < n; ++i)
      if (scanf("%lf", knots + i) != 1) return 2;
    for (int i = 0; i < size; ++i)
      if (scanf("%lf", points + i) != 1) return 2;
    SISLCurve* curve = newCurve(count, degree + 1, knots, points, rational ? 2 : 1, dimension, 1);
    if (!curve) {
      fprintf(stderr, "newCurve makes no curve\n");
      return 1;
    }
    for (int k = degree; k < n - degree - 1; ++k) {
      if (knots[k] == knots[k + 1]) continue;
      int status = print_derivatives(curve, dimension, knots[k], 0, 3);
      if (status >= 0) status = print_derivatives(curve, dimension, knots[k + 1], 1, 3);
      if (status < 0) {
        fprintf(stderr, "status %d\n", status);
        return 1;
      }
      printf("\n");
    }
    freeCurve(curve);
    free(knots);
    free(points);
  }
  return 0;
}
