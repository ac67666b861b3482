// What the declarations must accept, and what they must refuse.
import { GonioError, createGonio, type Profile, type Rig } from 'gonio';
import { iesSpotLight } from 'gonio/three';
import { DiskAreaLight, GonioAreaLights, SphereAreaLight, TubeAreaLight } from 'gonio/three-area-lights';

const gonio = await createGonio();
const profile: Profile = gonio.read(new Uint8Array(), 'lamp.ies');
const flux: number = profile.info().flux_lm;
const texels: Float32Array = profile.bake({ engine: 'three' }).data;
const numbers: number[] = gonio.units('800lm', ['nt', 'cd'], { shape: 'sphere:r=3cm' });
const rig: Rig = {
  schema: 'gonio.rig/1', stage: 'room', luminaires: { downlight: { shape: 'ies:lamp.ies' } },
  lights: [{ luminaire: 'downlight', target: [0, 0, 0], array: { count: [3, 2], spacing: [0.8, 1] } },
           { name: 'row', position: [1, 0, 0], rotate: '90deg', lights: [{ shape: 'cylinder:r=5cm,l=30cm', intensity: '800lm', positions: [[0, 0, 1], [0, 1, 1]] }] }],
};
const picture = gonio.preview(rig, {}, { width: 8, height: 8, mode: 'isolux' });
iesSpotLight({}, profile, { flux_lm: flux });
GonioAreaLights.init({ shapes: ['rect', 'tube'] });
const disk = new DiskAreaLight('white', 1000, 0.5);
disk.power = 800;
const metres: number = new TubeAreaLight(0xffffff, 1000, 0.02, 1.2).length + new SphereAreaLight().radius;
// @ts-expect-error: there is no such shape
GonioAreaLights.init({ shapes: ['ring'] });
// @ts-expect-error: a disk has no length
disk.length;
// @ts-expect-error: one unit gives one number
const wrong: number[] = gonio.units('800lm', 'nt');
// @ts-expect-error: a light has a shape or a luminaire
const dark: Rig = { schema: 'gonio.rig/1', lights: [{ position: [0, 0, 1] }] };
// @ts-expect-error: it is aimed or has a direction
const twice: Rig = { schema: 'gonio.rig/1', lights: [{ shape: 'point', direction: [0, 0, -1], target: [0, 0, 0] }] };
// @ts-expect-error: an array has a spacing or a room
const both: Rig = { schema: 'gonio.rig/1', lights: [{ shape: 'point', array: { count: [2, 2], spacing: [1, 1], room: [4, 4] } }] };
// @ts-expect-error: there is no such display mode
gonio.preview(rig, {}, { width: 8, height: 8, mode: 'look' });
export { GonioError, metres, numbers, picture, texels, both, dark, twice, wrong };
