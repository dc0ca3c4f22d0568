// layered.glsl -- multi-layer alpha blending (Salvi and Vaidyanathan 2014). Each of the nearest fragments has a layer of its own.
// All other fragments are merged into the last layer when they arrive.
#define MAX_STATE_FLOATS 32
#define STATE_ORDERED
#define HOLDS_COLORS
#define SETTINGS(S) S(int, layers) S(int, layer_bits)   // 1 to 6 layers; layer_bits: one of the formats below
const int LAYERS_IN_16_BITS = 0;   // half floats for colours, 16 bits for depth and transmittance
const int LAYERS_IN_8_BITS = 1;    // 8 bits for colours and transmittance, 16 for depth
const int LAYERS_IN_FLOATS = 2;    // nothing is rounded
#include "pixel_state.glsl"
#include "rounding.glsl"

const int MAX_LAYERS = 6;
const float NO_DEPTH = 2.0f;   // of an empty layer

/// Colours are multiplied by opacity.
struct Layer { float depth; float red; float green; float blue; float transmittance; };

FN Layer layer_of(IN(PixelState) state, int i)
{
    Layer layer;
    layer.depth = state.f[5 * i];
    layer.red = state.f[5 * i + 1];
    layer.green = state.f[5 * i + 2];
    layer.blue = state.f[5 * i + 3];
    layer.transmittance = state.f[5 * i + 4];
    return layer;
}

/// The colour that `bits` can hold. In 8 bits colours above 1 are clamped.
FN float stored_color(float x, int bits)
{
    if (bits == LAYERS_IN_FLOATS) return x;
    return bits == LAYERS_IN_8_BITS ? rounded_to_unorm8(x) : rounded_to_half(x);
}

/// The transmittance that `bits` can hold.
FN float stored_transmittance(float x, int bits)
{
    if (bits == LAYERS_IN_FLOATS) return x;
    return bits == LAYERS_IN_8_BITS ? rounded_to_unorm8(x) : rounded_to_unorm16(x);
}

/// The state holds depth, red, green, blue and transmittance of each layer. Layers are sorted by ascending depth.
FN PixelState empty_state(IN(PixelStateSettings) settings)
{
    PixelState state = zero_state();
    UNROLL
    for (int i = 0; i < MAX_LAYERS; ++i)
    {
        state.f[5 * i] = NO_DEPTH;
        state.f[5 * i + 4] = 1.0f;
    }
    return state;
}

/// `front` composited over `behind`. The result keeps the depth of `front`.
FN Layer merged(IN(Layer) front, IN(Layer) behind)
{
    Layer layer;
    PRECISE float red = front.red + front.transmittance * behind.red;
    PRECISE float green = front.green + front.transmittance * behind.green;
    PRECISE float blue = front.blue + front.transmittance * behind.blue;
    layer.depth = front.depth;
    layer.red = red;
    layer.green = green;
    layer.blue = blue;
    layer.transmittance = front.transmittance * behind.transmittance;
    return layer;
}

/// Inserts the fragment by one bubble pass through the sorted layers. What is pushed out behind the last layer is merged into it.
FN PixelState with_fragment(IN(PixelState) stored, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    PixelState state = empty_state(settings);
    Layer carried;
    carried.depth = settings.layer_bits == LAYERS_IN_FLOATS ? fragment.depth : rounded_to_unorm16(fragment.depth);
    carried.red = fragment.red * fragment.opacity;
    carried.green = fragment.green * fragment.opacity;
    carried.blue = fragment.blue * fragment.opacity;
    carried.transmittance = transmittance_of_opacity(fragment.opacity);
    UNROLL
    for (int i = 0; i < MAX_LAYERS; ++i)
    {
        Layer layer = layer_of(stored, i);
        Layer front = layer;
        Layer behind = carried;
        if (carried.depth <= layer.depth)   // at equal depths the later fragment lies in front, as with `sorted`
        {
            front = carried;
            behind = layer;
        }
        bool last = i == settings.layers - 1;
        if (last) front = merged(front, behind);
        bool there = i < settings.layers;
        state.f[5 * i] = there ? front.depth : NO_DEPTH;
        state.f[5 * i + 1] = there ? stored_color(front.red, settings.layer_bits) : 0.0f;
        state.f[5 * i + 2] = there ? stored_color(front.green, settings.layer_bits) : 0.0f;
        state.f[5 * i + 3] = there ? stored_color(front.blue, settings.layer_bits) : 0.0f;
        state.f[5 * i + 4] = there ? stored_transmittance(front.transmittance, settings.layer_bits) : 1.0f;
        carried = behind;
    }
    return state;
}

/// The product of the transmittances of all layers strictly in front of the fragment.
FN float transmittance_at(IN(PixelState) state, IN(PixelStateFragment) fragment, IN(PixelStateSettings) settings)
{
    float depth = settings.layer_bits == LAYERS_IN_FLOATS ? fragment.depth : rounded_to_unorm16(fragment.depth);
    float t = 1.0f;
    UNROLL
    for (int i = 0; i < MAX_LAYERS; ++i) t = state.f[5 * i] < depth ? t * state.f[5 * i + 4] : t;
    return t;
}

FN Composited composited(IN(PixelState) state, IN(PixelStateSettings) settings)
{
    Layer sum = layer_of(state, 0);
    UNROLL
    for (int i = 1; i < MAX_LAYERS; ++i) sum = merged(sum, layer_of(state, i));
    Composited result;
    result.red = sum.red;
    result.green = sum.green;
    result.blue = sum.blue;
    result.transmittance = sum.transmittance;
    return result;
}
