flat in uint v_visible;
out uint o_visible;

void main()
{
    o_visible = v_visible;
}
