/** What stands on a participant's pages, as a page of `conf/messages` gives it. */

export interface Screen {
  waiting: string;
  next_target: string;
  stop: string;
  stopped: string;
  connection_lost: string;
  no_picture: string;
  scene: string;
}

export interface Pages {
  pauses: {
    welcome: string;
    instructions: string[];
    ready: string;
    rest: string;
    rest_left: string;
    rest_over: string;
    countdown: string;
    starting: string;
    thanks: string;
    thanks_text: string;
  };
  consent: { step: string; asked: string; needed: string; ticks_needed: string; agree: string; decline: string };
  survey: {
    step: string;
    finish: string;
    optional: string;
    no_answer: string;
    answer_needed: string;
    number_needed: string;
    whole_number_needed: string;
    at_least: string;
    at_most: string;
  };
  controls: {
    next: string;
    back: string;
    read_on: string;
    full_screen: string;
    pad: string;
    letters: string[];
    space: string;
    delete: string;
  };
}
