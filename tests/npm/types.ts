// What the declarations must accept, and what they must refuse.
import { GonioError, createGonio, type Profile } from 'gonio';
import { iesSpotLight } from 'gonio/three';

const gonio = await createGonio();
const profile: Profile = gonio.read(new Uint8Array(), 'lamp.ies');
const flux: number = profile.info().flux_lm;
const texels: Float32Array = profile.bake({ engine: 'three' }).data;
const numbers: number[] = gonio.units('800lm', ['nt', 'cd'], { shape: 'sphere:r=3cm' });
const picture = gonio.preview({}, {}, { width: 8, height: 8, mode: 'isolux' });
iesSpotLight({}, profile, { flux_lm: flux });
// @ts-expect-error: one unit gives one number
const wrong: number[] = gonio.units('800lm', 'nt');
// @ts-expect-error: there is no such display mode
gonio.preview({}, {}, { width: 8, height: 8, mode: 'look' });
export { GonioError, numbers, picture, texels, wrong };
