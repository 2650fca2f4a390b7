# SPDX-License-Identifier: CC0-1.0
"""The joins of chains of curves."""

from truth import Join


def chain_join(left, right):
    """Returns the join of the end of a curve and the start of another one."""
    k, m = left.spans()[-1], right.spans()[0]
    return Join(left.jet(k, True), right.jet(m, False), (left.is_straight(k), right.is_straight(m)))


def chain_joins(chain, closed):
    """All, with those at inner knots."""
    ends = [(c, k) for c in chain for k in c.spans()]
    result = []
    for i in range(len(ends) if closed else len(ends) - 1):
        (a, k), (b, m) = ends[i], ends[(i + 1) % len(ends)]
        result.append(Join(a.jet(k, True), b.jet(m, False), (a.is_straight(k), b.is_straight(m))))
    return result
