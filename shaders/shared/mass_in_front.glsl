// mass_in_front.glsl -- the share of b_0 in front of the query depth, computed from the masses of as few nodes as possible.
//
// The nodes are sorted by t. The nodes in front of the query come first, then those in the wrapping zone, then those behind. All
// nodes together have the mass 1 - w_0. So it is enough to know the masses of the nodes in front and in the zone, or those of the
// nodes in the zone and behind. The basis defines KNOWN_NODES, the number of masses that are needed. With two nodes on the line no
// mass is needed.

#if defined(LINE_BASIS) && ROOT_COUNT == 2
FN float mass_in_front(IN(Roots) roots, float rest, IN(Query) query, IN(Factor) factor, IN(Basis) basis)
{
    return mass_in_front_of_two(roots.t[0], roots.t[1], rest, query);
}
#else
/// Sorts the roots in ascending order by a fixed network of comparisons.
FN Roots sorted_roots(IN(Roots) roots)
{
    Roots sorted = roots;
    UNROLL
    for (int last = ROOT_COUNT - 1; last > 0; --last)
    {
        UNROLL
        for (int l = 0; l < last; ++l)
        {
            float first = min(sorted.t[l], sorted.t[l + 1]);
            float second = max(sorted.t[l], sorted.t[l + 1]);
            sorted.t[l] = first;
            sorted.t[l + 1] = second;
        }
    }
    return sorted;
}

/// Returns 1 if the masses of the first KNOWN_NODES nodes shall be added up, and 0 if those of the last KNOWN_NODES nodes shall.
/// Adding up the first is right if all other nodes are behind. Adding up the last is right if all other nodes are in front. If both
/// are right, the one with less rounding is chosen. If two nodes nearly coincide, rounding spoils the sum of their masses, so these
/// are better left out. Otherwise the first are better: the error is then relative to the mass in front, which may be small, and
/// not to b_0.
FN float adds_from_front(IN(Roots) nodes, IN(Query) query, IN(Basis) basis)
{
#if defined(LINE_BASIS) && ROOT_COUNT == 3
    return 1.0f - node_in_front(nodes.t[1], query);
#elif ROOT_COUNT == 2
    return node_behind(nodes.t[1], query, basis);
#elif defined(LINE_BASIS)
    // The gap of the first two nodes and the gap of the last two, each divided by the size of its nodes. Both are multiplied by
    // both sizes, so no division is needed. The first gap counts twice: the first nodes are added up unless the gap of the last two
    // is at least twice as large.
    PRECISE float front = 2.0f * (nodes.t[1] - nodes.t[0]) * (1.0f + max(abs(nodes.t[2]), abs(nodes.t[3])));
    PRECISE float behind = (nodes.t[3] - nodes.t[2]) * (1.0f + max(abs(nodes.t[0]), abs(nodes.t[1])));
    float either = front > behind ? 1.0f : 0.0f;
    return (1.0f - node_in_front(nodes.t[2], query)) * max(1.0f - node_in_front(nodes.t[1], query), either);
#else
    // front: the smallest relative gap between two neighbours of which one is in front and the other is in front or in the zone.
    // behind: the same for nodes behind. A term of 2 excludes all other pairs. Conditions are products of 0 and 1, because
    // compilers do not vectorise nested conditions.
    float front = 1.2f;    // for a side with fewer than two nodes
    float behind = 1.2f;
    UNROLL
    for (int l = 1; l < ROOT_COUNT; ++l)
    {
        float size = 1.0f + max(abs(nodes.t[l - 1]), abs(nodes.t[l]));
        PRECISE float gap = (nodes.t[l] - nodes.t[l - 1]) / size;
        float first_in_front = node_in_front(nodes.t[l - 1], query);
        float second_behind = node_behind(nodes.t[l], query, basis);
        front = min(front, gap + 2.0f * (1.0f - first_in_front * (1.0f - second_behind)));
        behind = min(behind, gap + 2.0f * (1.0f - second_behind * (1.0f - first_in_front)));
    }
    float either = 2.0f * front > behind ? 1.0f : 0.0f;
    float first_in_front = node_in_front(nodes.t[0], query);
    return node_behind(nodes.t[ROOT_COUNT - 1], query, basis) * max(1.0f - first_in_front, either);
#endif
}

/// The sum of mass times value over all nodes, in [0, rest]. rest: the mass of all nodes.
FN float mass_in_front(IN(Roots) roots, float rest, IN(Query) query, IN(Factor) factor, IN(Basis) basis)
{
    Roots nodes = sorted_roots(roots);
    float from_front = adds_from_front(nodes, query, basis);
    PRECISE float sum = 0.0f;
    UNROLL
    for (int l = 0; l < KNOWN_NODES; ++l)
    {
        float t = from_front > 0.0f ? nodes.t[l] : nodes.t[ROOT_COUNT - 1 - l];
        float value = node_value(t, query, basis);
        float share = from_front > 0.0f ? value : 1.0f - value;
        sum = sum + node_weight(t, query, factor) * share;
    }
    sum = min(sum, rest);
    return from_front > 0.0f ? sum : rest - sum;
}
#endif
