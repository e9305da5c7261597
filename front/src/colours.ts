/** Colours that carry meaning; a test holds every pair apart for colour-blind eyes. */

import colours from "./colours.json";

export const FORCE_X = colours.fx;
export const FORCE_Y = colours.fy;
export const RESULTANT = colours.resultant;
export const TORQUE_LEFT = colours.torque_left;
export const TORQUE_RIGHT = colours.torque_right;
export const CLEARANCE = colours.clearance;
export const TRAIL = colours.trail;
export const COLLISION = colours.collision;
export const BOUNDARY = colours.boundary;
