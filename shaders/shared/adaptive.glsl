// adaptive.glsl -- adaptive transparency (Salvi, Montgomery and Lefohn 2011). The transmittance is a step function with few nodes.
// If there are too many nodes, the one that matters least is removed.
#define MAX_STATE_FLOATS 16
#define STATE_ORDERED
#define SETTINGS(S) S(int, nodes)   // 2 to 8
#include "pixel_state.glsl"

const int MAX_NODES = 8;
const float NO_DEPTH = 2.0f;   // of an empty node: behind every fragment

struct NodeList { float depth[9]; float t[9]; };

/// The state holds a pair for each node: its depth and the transmittance behind it. Nodes are sorted by ascending depth. Empty
/// nodes hold the total transmittance.
FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    PixelState state;
    UNROLL
    for (int i = 0; i < MAX_NODES; ++i)
    {
        state.f[2 * i] = NO_DEPTH;
        state.f[2 * i + 1] = 1.0f;
    }
    return state;
}

/// The stored nodes and one more for the fragment, which occludes itself and everything behind it. size: the number of stored
/// nodes.
FN NodeList with_node(IN(PixelState) stored, IN(PixelStateFragment) fragment, int size)
{
    NodeList list;
    float through = transmittance_of_opacity(fragment.opacity);
    float depth_before = -1.0f;
    float t_before = 1.0f;
    UNROLL
    for (int i = 0; i <= MAX_NODES; ++i)
    {
        bool last = i == size;
        float depth = last || i >= MAX_NODES ? NO_DEPTH : stored.f[2 * min(i, MAX_NODES - 1)];
        float t = last || i >= MAX_NODES ? t_before : stored.f[2 * min(i, MAX_NODES - 1) + 1];
        bool stays = depth < fragment.depth;
        bool is_new = !stays && depth_before < fragment.depth;
        list.depth[i] = stays ? depth : (is_new ? fragment.depth : depth_before);
        list.t[i] = stays ? t : t_before * through;
        depth_before = depth;
        t_before = t;
    }
    return list;
}

/// Index of the node to remove from size + 1 nodes. Never the first. The last only if it is empty.
FN int least_node(IN(NodeList) list, int size)
{
    int least = size;
    float least_area = 1.0e30f;
    bool full = list.depth[size] < NO_DEPTH;
    UNROLL
    for (int i = 1; i < MAX_NODES; ++i)
    {
        PRECISE float area = (list.depth[i] - list.depth[i - 1]) * (list.t[i - 1] - list.t[i]);
        bool better = full && i < size && area < least_area;
        least = better ? i : least;
        least_area = better ? area : least_area;
    }
    return least;
}

FN PixelState with_fragment(IN(PixelState) stored, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    NodeList list = with_node(stored, fragment, settings.nodes);
    int removed = least_node(list, settings.nodes);
    PixelState state = empty_state(settings);
    UNROLL
    for (int i = 0; i < MAX_NODES; ++i)
    {
        bool there = i < settings.nodes;
        state.f[2 * i] = there ? (i < removed ? list.depth[i] : list.depth[i + 1]) : NO_DEPTH;
        state.f[2 * i + 1] = i < removed - 1 ? list.t[i] : list.t[i + 1];   // T is too small from node removed - 1 to node removed
    }
    return state;
}

/// The transmittance of the last node strictly in front of the fragment; 1 if there is none.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float t = 1.0f;
    UNROLL
    for (int i = 0; i < MAX_NODES; ++i) t = i < settings.nodes && state.f[2 * i] < fragment.depth ? state.f[2 * i + 1] : t;
    return t;
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    return transparent(state.f[2 * settings.nodes - 1]);
}
