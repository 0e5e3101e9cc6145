/** Which release this is: what stands in double braces the build fills in, as in the documents. */

export const RELEASE = Object.freeze({ version: "{{version}}", commit: "{{commit}}" });
