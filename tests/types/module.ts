// What TypeScript users may write and may not: checked by the compiler alone, never run.

import {
  type Figure,
  type Gear,
  GearError,
  type GearErrorCode,
  type Parameters,
  load,
} from "../../www/engine/gear-bifurcations.js";

const gear: Gear = await load();
await load(new Uint8Array(8));
await load(fetch("gear-bifurcations_bg.wasm"));
await load(gear.module);

const p: Parameters = { m: 1, k_g: 5, Omega: 1.6, regime: "contact" };
// @ts-expect-error names are matched exactly
const wrongName: Parameters = { omega: 1.6 };
// @ts-expect-error numbers are numbers
const wrongType: Parameters = { k0: "0.5" };
// @ts-expect-error there are three regimes
const wrongRegime: Parameters = { regime: "free" };

const omega: Float64Array = gear.modes(p).omega;
const left: number | null = gear.tongues().primary2.hill?.left ?? null;
const { re, im, stable } = gear.multipliers(p, { tolerance: 1e-8 });
const columns: Float64Array[] = [re, im, omega];
const escaped: number | null = gear.timeResponse(p, { state: [0, 0, 1, 0, 0, 0], periods: 3 }).escaped;
gear.poincare(p, { state: new Float64Array(6), transient: 10, points: 5 });
gear.periodicOrbit(p, { period: 2, guess: re });
// @ts-expect-error no such option
gear.poincare(p, { period: 2 });

const figure: Figure = gear.figure("9", p);
const liouville: number | undefined = figure.error.liouville;
const text: string = gear.svg(figure, undefined, { width: 640, theme: "dark", view: { azimuth: 1 } });
const canvas = document.createElement("canvas");
const plotLeft: number | undefined = gear.draw("9", p, canvas, { density: 2 }).frames[0]?.plot.left;
// @ts-expect-error it draws on a canvas
gear.draw("9", p, document.body);

for (const { figure: soFar, done } of gear.progress("12a")) {
  const step: [string, boolean] = [soFar.summary, done];
  if (step[1]) break;
}
for (const control of gear.figures()[0]?.parameters ?? []) {
  // The regime is told apart by its name.
  const choices: number | readonly string[] = control.name === "regime" && "choices" in control ? control.choices : 0;
  void choices;
}

const { params, scales } = gear.fromPhysical({
  M_p: 1, M_g: 1, I_p: 1, I_g: 1, r_p: 1, r_g: 1, K: 1, K_p: 1, K_g: 1, b: 1, teeth_p: 20, rpm_p: 100,
});
const hertz: number = gear.toPhysical(params, scales).mesh_frequency;
// @ts-expect-error quantities that are needed must be there
gear.fromPhysical({ M_p: 1 });

try {
  gear.defaults();
} catch (error) {
  if (error instanceof GearError) {
    const code: GearErrorCode = error.code;
    const allowed: string | [number, number] | null = error.allowed;
    void [code, allowed, error.toJSON().given];
  }
}

void [wrongName, wrongType, wrongRegime, left, stable, columns, escaped, liouville, text, plotLeft, hertz];
