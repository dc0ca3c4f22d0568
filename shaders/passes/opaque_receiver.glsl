// opaque_receiver.glsl -- for passes that shade opaque surfaces. These are in the light's map of opaque casters alone.
#ifdef SHADOWS
float receiver_absorbance()
{
    return 0.0;
}
#endif
