"use strict";
// Before anything is drawn: the colours that the system asks for, and that there is a script.
document.documentElement.classList.add("scripted");
document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
