// The filter of the glow: the 13 cells on the two diagonals of a 7x7 grid, equal weights that sum to 1.
//
// Mihálik 2008, section 9.3. The printed listing tests `k <> 0 AND l <> 0`, which names 36 cells, and adds the centre
// each time; the prose (13 elements on the diagonals of the grid, each divided by 13) is what is done here.

const int glowReach = 3; // cells from the centre to the corner

// Weight of the cell at an offset from the centre.
SHARED float glowWeight(int x, int y)
{
    bool onDiagonal = (x == y) || (x == -y);
    bool inside = x >= -glowReach && x <= glowReach && y >= -glowReach && y <= glowReach;
    return onDiagonal && inside ? 1.0 / 13.0 : 0.0;
}
