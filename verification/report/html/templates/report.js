// A link into a closed sheet opens it; so does printing, for all.
function openTo(hash) {
  const target = hash && document.getElementById(decodeURIComponent(hash.slice(1)));
  for (let up = target; up; up = up.parentElement) if (up.tagName === "DETAILS") up.open = true;
  if (target) target.scrollIntoView();
}
function openAll() {
  for (const sheet of document.querySelectorAll("details")) sheet.open = true;
  for (const picture of document.images) picture.loading = "eager";
}
addEventListener("hashchange", () => openTo(location.hash));
addEventListener("beforeprint", openAll);
if (location.hash === "#print") openAll(); else openTo(location.hash);
