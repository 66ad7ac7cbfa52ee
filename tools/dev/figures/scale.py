"""How much is rendered: the report's figures, a quick look, or what a test can wait for."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Scale:
    name: str
    size: int            # pixels a side
    spp: tuple           # of figure 1
    reference_spp: dict  # by scene; figure 5 needs less than figure 1
    overview_spp: int    # of figure 2; the report's is 64
    detail_size: int     # pixels a side of the pictures that figures 3 and 4 are crops of
    detail_spp: int
    strategy_spp: int    # of figure 5; the report's is 16
    course_size: int
    course_spp: int
    encoded_size: int
    encoded_seeds: int   # a power of 2
    furnace_size: int
    furnace_spp: int
    roughness: tuple


SPP = (1, 4, 16, 64, 256, 1024)
ROUGHNESS = (.05, .1, .2, .3, .4, .5, .6, .7, .8, .9, 1)


def references(metal, diffuse):
    return {"cornell_box": metal, "cornell_box_diffuse": diffuse}


FULL = Scale("full", 400, SPP, references(4096, 1024), 64, 1024, 256, 16, 360, 16, 128, 128, 64,
             256, ROUGHNESS)
QUICK = Scale("quick", 128, SPP, references(2048, 1024), 64, 512, 64, 16, 160, 8, 64, 32, 48, 64,
              ROUGHNESS)
TINY = Scale("tiny", 32, (1, 4), references(64, 64), 4, 128, 4, 16, 32, 1, 16, 4, 16, 16, (.2, 1))
