// Returns the index of an invocation among those of all work groups, of which there may be several rows: a row has no
// more than OpenGL guarantees.
uint index_of()
{
    return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
}
